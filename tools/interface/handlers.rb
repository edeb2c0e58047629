# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'c'
require_relative 'routes'

module Interface
  # The dispatch of the HTTP server: the function that answers each route, and the declaration of each of them.
  #
  # @satisfies SWR-TOOL-070
  class Handlers
    FROM = 'core/interface'
    SAYS = 'What answers each route of the HTTP server.'

    def initialize(model)
      @routes = model.routes
      @commands = model.commands
    end

    def files
      @routes ? { 'handlers.h' => header, 'handlers.c' => source } : {}
    end

    private

    def header
      C.file(SAYS, FROM) + C.guard('handlers', <<~CODE)
        #include "http/call/http_call.h"
        #include "http/call/http_context.h"
        #include "interface/app/routes.h"

        /** Answers a request that is judged and read. Returns the status that was sent. */
        typedef int (*http_handler_t)(http_server_t *server, const http_call_t *call);

        /** By route_id_t. */
        extern const http_handler_t http_handlers[ROUTE_COUNT];

        #{@routes.routes.select(&:handler).group_by(&:handler).map { |handler, routes| declaration(handler, routes) }.join("\n").chomp}
      CODE
    end

    def declaration(handler, routes)
      says = routes.size == 1 ? ": #{routes.first.says}" : '.'
      "#{C.comment(routes.map { |route| "#{route.method} #{route.path}" }.join(', ') + says)}" \
        "int #{handler}(http_server_t *server, const http_call_t *call);\n"
    end

    def source
      senders = @routes.routes.reject(&:handler)
      rows = @routes.routes.map { |route| "    [ROUTE_#{route.name.upcase}] = #{route.handler || name(route)},\n" }
      <<~CODE
        #{C.file(SAYS, FROM).chomp}
        #include "handlers.h"

        #{"#include \"http/call/http_act.h\"\n\n" unless senders.empty?}#{senders.map { |route| "#{sender(route)}\n" }.join}const http_handler_t http_handlers[ROUTE_COUNT] = {
        #{rows.join}};
      CODE
    end

    def name(route)
      "send_#{route.name}"
    end

    # Sends the command as body and path say it.
    #
    # @satisfies SWR-TOOL-310
    def sender(route)
      payload = @commands.payloads.of(route.command)
      said = route.fields.map { |field, expression| ".#{field} = #{expression}" }.join(', ')
      <<~CODE
        static int #{name(route)}(http_server_t *server, const http_call_t *call)
        {
        #{tables(route)}    const request_#{route.body.name}_t *body = &call->body.#{@routes.body_name(route)};
            const command_t command = {.id = body->id, .kind = (uint32_t)#{@commands.constant(route.command)}#{", .as.#{payload.name} = {#{said}}" if payload}};
            return http_act_command(server, call, &command);
        }
      CODE
    end

    def tables(route)
      route.tables.map { |field, values| "    static const uint32_t #{field}_values[] = {#{values.map { |one| "(uint32_t)#{one}" }.join(', ')}};\n" }.join
    end
  end
end
