# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'routes'

module Interface
  # The routes and the problems of the HTTP server as tables in C.
  #
  # @satisfies SWR-TOOL-019
  class RouteTable
    FROM = 'core/interface'
    SAYS = 'What can be asked of the HTTP server, and why it refuses.'

    def initialize(model)
      @routes = model.routes
    end

    def files
      @routes ? { 'routes.h' => header, 'routes.c' => source } : {}
    end

    private

    def header
      C.file(SAYS, FROM) + C.guard('routes', <<~CODE)
        #include "interface/app/requests.h"
        #include "interface/role.h"

        /** Answered routes; a GET answers HEAD too. */
        typedef enum {
        #{enumerators('ROUTE', @routes.routes)}
        } route_id_t;

        #define ROUTE_COUNT #{@routes.routes.size}U
        #define ROUTE_BODY_MOST #{@routes.routes.reject(&:sends).map(&:body_most).max}U /**< Bytes of the longest body of JSON. */
        #define ROUTE_SENT_MOST #{@routes.routes.select(&:sends).map(&:body_most).max.to_i}U /**< The same of those that routes read themselves. */

        /** Kind of the part of a path in braces. */
        typedef enum {
            ROUTE_PLAIN = 0,  /**< Nothing. */
            ROUTE_OF_AXIS = 1,   /**< {axis}: an axis, by its name or its number. */
            ROUTE_OF_NUMBER = 2, /**< {number}: a whole number. */
            ROUTE_OF_NAME = 3    /**< {name}: letters, digits, _, . and -, none of these first. */
        } route_value_t;

        /** When the log has a request, with its answer. */
        typedef enum {
            ROUTE_NOTED_ALWAYS = 0,
            ROUTE_NOTED_REFUSED = 1,
            ROUTE_NOTED_NEVER = 2
        } route_noted_t;

        /** A path with a method. */
        typedef struct {
            route_id_t id;
            const char *method;
            const char *path;
            route_value_t value;
            const char *allowed;            /**< All methods of the path. */
            bool is_for_anyone;             /**< It needs no session, and no token of one. */
            role_t role;                    /**< The least that it needs. */
            bool is_of_page;                /**< The request names its page. */
            bool needs_authority;           /**< That page has authority. */
            uint32_t command;               /**< command_kind_t that it sends; 0: none. */
            bool is_listed;                 /**< GET /api/v1/modes lists whether this is allowed. */
            bool is_lenient;                /**< Media type and query are not looked at. */
            route_noted_t noted;
            size_t body_most;               /**< Bytes; 0: there must be no body. */
            const char *sends;              /**< Media type of a body that the route reads itself; NULL: none. */
            const request_message_t *body;  /**< NULL: none. */
            const request_message_t *query;
        } route_t;

        extern const route_t routes[ROUTE_COUNT];

        /** Why a request is refused. */
        typedef enum {
        #{enumerators('PROBLEM', @routes.problems)}
        } problem_t;

        #define PROBLEM_COUNT #{@routes.problems.size}U

        /** Words for clients about a problem. */
        typedef struct {
            int http;
            const char *code;
            const char *detail;
        } problem_words_t;

        extern const problem_words_t problems[PROBLEM_COUNT];
      CODE
    end

    def enumerators(prefix, all)
      lines = all.each_with_index.map do |one, index|
        "#{C.comment(one.says, '    ')}    #{prefix}_#{one.name.upcase} = #{index}"
      end
      lines.join(",\n")
    end

    def source
      "#{C.file(SAYS, FROM)}#include \"routes.h\"\n\n" \
        "const route_t routes[ROUTE_COUNT] = {\n#{@routes.routes.map { |route| row(route) }.join(",\n")}};\n\n" \
        "const problem_words_t problems[PROBLEM_COUNT] = {\n#{@routes.problems.map { |one| words(one) }.join(",\n")}};\n"
    end

    def row(route)
      body = route.body ? "&request_#{route.body.name}" : 'NULL'
      query = route.parameters.members.empty? ? 'nothing' : route.parameters.name
      "    {ROUTE_#{route.name.upcase}, #{C.string(route.method)}, #{C.string(route.path)}, " \
        "#{value(route)}, #{C.string(@routes.allowed(route.path))},\n     #{route.anyone?}, #{least(route)}, " \
        "#{route.page?}, #{route.authority?}, #{asked(route)}, #{route.listed?}, #{route.lenient?}, #{noted(route)}, " \
        "#{route.body_most}U, #{sent(route)}, #{body}, &request_#{query}}"
    end

    def noted(route)
      "ROUTE_NOTED_#{route.noted.upcase}"
    end

    def asked(route)
      "#{route.command&.code.to_i}U"
    end

    def sent(route)
      route.sends ? C.string(route.sends) : 'NULL'
    end

    def value(route)
      route.value ? "ROUTE_OF_#{route.value.upcase}" : 'ROUTE_PLAIN'
    end

    # The first role may least.
    def least(route)
      route.anyone? ? '(role_t)0' : "ROLE_#{route.who}"
    end

    def words(problem)
      "    {#{problem.http}, #{C.string(problem.name)},\n     #{C.string(problem.says)}}"
    end
  end
end
