# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative '../c'
require_relative '../node'

module Interface
  # Data of answers: for each form a structure answer_FORM, all of them as a tagged union with checked accessors. Of an accepted
  # command the form is `gives` of the `answers` of its row, of a refused one as the column `names_axis` of its status says, and as
  # far as a coupled limit of a robot refuses with it; an order that has ended early has the form `ended`.
  #
  # @satisfies SWR-TOOL-480
  class AnswerForms
    PREFIX = 'answer_'
    MODULE = 'answer'
    GIVES = 'gives'
    # Forms of a refusal, by whether it names the axis and the end of a limit.
    OF_REFUSALS = { [true, false] => 'axis', [true, true] => 'limit', [false, true] => 'shared_limit' }.freeze
    OF_ENDS = 'ended'
    FROM = 'core/interface'
    C_TYPE = 'answer_data_t'

    def initialize(model)
      @model = model
      @kinds = model.enumeration('command_kind')
      @statuses = model.enumeration('status')
      @given = @kinds.values.group_by { |value| given(value) }.tap { |all| all.delete(nil) }
      @structures = names.to_h { |name| [name, structure(name)] }
      unused
    end

    # By the constants of their forms.
    def structures
      @structures.transform_keys { |name| constant(name) }
    end

    def c_type
      C_TYPE
    end

    def bytes
      @structures.values.map(&:bytes).max
    end

    def alignment
      4
    end

    # The largest one first: then an initializer clears all bytes.
    def union
      members = @structures.sort_by { |_, one| -one.bytes }.map { |name, one| "    #{one.name}_t #{name}; /**< #{about(name)} */\n" }
      "/** Data of an answer, in the member of its form. */\ntypedef union {\n#{members.join}} #{C_TYPE};\n"
    end

    def prototypes
      forms = names.each_with_index.map { |name, index| "    #{constant(name)} = #{index + 1}" }
      <<~CODE
        /** Which member of #{C_TYPE} an answer has. */
        typedef enum {
            #{constant('none')} = 0,
        #{forms.join(",\n")}
        } answer_form_t;

        /** Form of `answer`, by its command, kind and status. */
        answer_form_t answer_form(const answer_t *answer);

        /** Refuses the command of `answer`, which has no data yet, with a status_t: the axis and the end of the limit are said as
         * far as its form has them. */
        void answer_refuse(answer_t *answer, uint32_t status, uint32_t axis, uint32_t is_maximum);

        /** Axis that an answer names; ROBOT_AXIS_MAX: none. */
        uint32_t answer_axis(const answer_t *answer);

        #{names.map { |name| accessor(name) }.join("\n").chomp}
      CODE
    end

    def files
      { 'answer.c' => source, 'answer_access.c' => access }
    end

    private

    def given(value)
      value.more['answers']&.at(GIVES)&.identifier
    end

    def names
      @names ||= @given.keys + [*refusals.map(&:last), OF_ENDS].uniq
    end

    def constant(name)
      "ANSWER_FORM_#{name.upcase}"
    end

    def structure(name)
      @model.structure("#{PREFIX}#{name}") || raise(Refused.new(FROM, "#{PREFIX}#{name}", 'is missing: answers have this form'))
    end

    def unused
      header = @structures.values.first.header
      unknown = @model.structures.find do |one|
        one.header == header && one.name.start_with?(PREFIX) && !@structures.value?(one)
      end
      raise Refused.new(FROM, unknown.name, 'is the form of no answer') if unknown
    end

    def about(name)
      return "Accepted: #{@given[name].map(&:name).join(', ')}." if @given.key?(name)

      name == OF_ENDS ? 'Ended early.' : 'Refused.'
    end

    # [status, the commands of which it names the axis, form], for each form that refusals with it have.
    def refusals
      @refusals ||= @statuses.values.flat_map do |status|
        commands = @model.statuses.named(status)
        has_end = @model.limit_end?(status)
        rows = []
        rows << [status, commands, OF_REFUSALS.fetch([true, has_end])] if commands
        rows << [status, nil, OF_REFUSALS.fetch([false, true])] if has_end && commands != Statuses::ANY
        rows
      end
    end

    # The C expression of the form of a refusal.
    def choice(rows)
      listed = rows.find { |row| row[1].is_a?(Array) }
      other = rows.reject { |row| row[1].is_a?(Array) }.map { |row| constant(row.last) }.first || constant('none')
      return other unless listed

      tests = listed[1].map { |name| "(command == (uint32_t)#{@kinds.prefix}_#{name})" }
      all = tests.one? ? tests.first : "(#{tests.join(" ||\n                ")})"
      "#{all} ? #{constant(listed.last)} : #{other}"
    end

    def source
      <<~CODE
        #{C.file('Forms of answers.', FROM).chomp}
        #include "answer.h"

        #include "robot/robot.h"

        #{given_function}
        #{refused_function}
        #{FORM}
        #{refuse_function}
        #{axis_function}
      CODE
        .sub(/\n+\z/, "\n")
    end

    def given_function
      cases = @given.map { |name, values| [values.map { |value| @kinds.constant(value) }, constant(name)] }
      function('given', 'command', 'uint32_t command', cases)
    end

    def refused_function
      cases = refusals.group_by(&:first).group_by { |_, rows| choice(rows) }.map do |form, all|
        [all.map { |status, _| @statuses.constant(status) }, form]
      end
      function('refused', 'status', "uint32_t command, uint32_t status", cases,
               cases.any? { |_, form| form.include?('command') } ? '' : "    (void)command;\n")
    end

    def function(name, key, parameters, cases, first = '')
      <<~CODE
        static answer_form_t #{name}(#{parameters})
        {
        #{first}    answer_form_t form = #{constant('none')};
            switch (#{key}) {
        #{cases.map { |constants, form| labels(constants) + "        form = #{form};\n        break;\n" }.join}    default:
                break;
            }
            return form;
        }
      CODE
    end

    def labels(constants)
      constants.map { |one| "    case (uint32_t)#{one}:\n" }.join
    end

    FORM = <<~CODE
      answer_form_t answer_form(const answer_t *answer)
      {
          answer_form_t form = ANSWER_FORM_NONE;
          switch (answer->kind) {
          case (uint32_t)ANSWER_ACCEPTED:
              form = given(answer->command);
              break;
          case (uint32_t)ANSWER_REFUSED:
              form = refused(answer->command, answer->status);
              break;
          case (uint32_t)ANSWER_ABORTED:
              form = ANSWER_FORM_ENDED;
              break;
          default:
              break;
          }
          return form;
      }
    CODE

    REFUSED_FIELDS = %w[axis is_maximum].freeze

    # The form has its data in the fields of these names.
    def refuse_function
      cases = OF_REFUSALS.values.select { |name| @structures.key?(name) }.map do |name|
        fields = @structures[name].fields.map(&:name)
        "    case (uint32_t)#{constant(name)}:\n" +
          (fields & REFUSED_FIELDS).map { |field| "        answer->as.#{name}.#{field} = #{field};\n" }.join + "        break;\n"
      end
      <<~CODE
        void answer_refuse(answer_t *answer, uint32_t status, uint32_t axis, uint32_t is_maximum)
        {
            answer->kind = (uint32_t)ANSWER_REFUSED;
            answer->status = status;
            switch ((uint32_t)answer_form(answer)) {
        #{cases.join}    default:
                break;
            }
        }
      CODE
    end

    # Of each form with an axis.
    def axis_function
      cases = @structures.select { |_, one| one.fields.any? { |field| field.name == 'axis' } }.keys.map do |name|
        "    case (uint32_t)#{constant(name)}:\n        axis = answer->as.#{name}.axis;\n        break;\n"
      end
      <<~CODE
        uint32_t answer_axis(const answer_t *answer)
        {
            uint32_t axis = ROBOT_AXIS_MAX;
            switch ((uint32_t)answer_form(answer)) {
        #{cases.join}    default:
                break;
            }
            return axis;
        }
      CODE
    end

    # @satisfies SWR-CMD-480
    # Apart: a program that takes none of them need not say what becomes of a broken contract.
    def access
      functions = names.each_with_index.map do |name, index|
        <<~CODE
          const #{PREFIX}#{name}_t *answer_as_#{name}(const answer_t *answer)
          {
              REQUIRE(#{index + 1}U, answer_form(answer) == #{constant(name)});
              return &answer->as.#{name};
          }
        CODE
      end
      <<~CODE
        #{C.file('Data of an answer, by its form.', FROM).chomp}
        #include "answer.h"

        #include "base/contract.h"

        #include <stdbool.h>

        static const char contract_module[] = "#{MODULE}";

        #{functions.join("\n").chomp}
      CODE
    end

    def accessor(name)
      "/** #{about(name)} Contract #{names.index(name) + 1}. */\nconst #{PREFIX}#{name}_t *answer_as_#{name}(const answer_t *answer);\n"
    end
  end
end
