# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative '../c'
require_relative '../node'

module Interface
  # The answers that each command may get, of three sources: `answers` of the command's row, the columns `refuses` and `ends` of
  # the statuses, and the mode that it arms, which makes its first answer not the last one.
  #
  # @satisfies SWR-TOOL-340
  class Answers
    FROM = 'core/interface'
    SAYS = 'The answers that each command may get.'
    KIND = 'answer_kind'
    PARTS = %w[refused ended gives].freeze
    # In place of the refusals of the robots' kinematics.
    ROBOTS = 'robots'
    ROBOT_REFUSALS = "a refusal of the robot's kinematics"
    # Commands that a status may refuse without a word of it in their rows, by the word of its `refuses`.
    GROUPS = {
      'every' => ->(_, _) { true },
      'authorised' => ->(answers, value) { !answers.in_set?('FREE', value) },
      'tabled' => ->(answers, value) { !answers.in_set?('TABLELESS', value) },
      'bound' => ->(answers, value) { !answers.commands.sentence(value).empty? },
      'arming' => ->(answers, value) { !answers.commands.mode(value).nil? },
      'homed' => ->(answers, value) { answers.commands.mode(value)&.unhomed == false }
    }.freeze

    # One answer: `kind` and `status` are names of values, `is_final` says that no other one follows.
    Answer = Struct.new(:kind, :status, :is_final)

    attr_reader :commands

    def initialize(model)
      @model = model
      @commands = model.commands
      @kinds = model.enumeration('command_kind')
      @statuses = model.enumeration('status')
      to_a
    end

    # For the processes.
    class Files
      def initialize(model)
        @answers = model.answers
      end

      def files
        @answers ? @answers.files : {}
      end
    end

    # Each command with its answers.
    def to_a
      @to_a ||= @kinds.values.map { |value| [value, of(value)] }
    end

    # The statuses with which it may be refused, in the order of their codes.
    def refused(value)
      sum(value, 'refused', of_column('refuses') { |node| in_group?(node.choice(GROUPS.keys), value) })
    end

    # Those with which an order that it has armed may end early.
    def ended(value)
      return [] unless arms?(value)

      sum(value, 'ended', of_column('ends', &:true?))
    end

    # One of its answers may not be the last one.
    def arms?(value)
      always_arms?(value) || value.name == Modes::BY_WORKPHASE
    end

    def in_set?(name, value)
      @kinds.sets.find { |set| set.name == name }&.values.to_a.include?(value)
    end

    # The statuses of what a route sends: those of its command, and of others whose row names that in place of a request.
    def of_route(route, part)
      sent = @kinds.values.select { |value| value == route.command || value.more['http']&.then { |node| node.scalar? && node.word == route.command&.name } }
      in_order(sent.flat_map { |value| public_send(part, value) } - (part == :refused ? of_column('refuses') { |node| node.word == 'every' } : []))
    end

    # For people: the refusals of the robots are one word.
    def shown(names)
      robots = of_robots
      has_robots = robots.any? && (robots - names).empty?
      (has_robots ? names - robots : names).map { |name| "`#{name}`" } + (has_robots ? [ROBOT_REFUSALS] : [])
    end

    def files
      { 'answer_list.h' => header, 'answer_list.c' => source }
    end

    private

    def always_arms?(value)
      !commands.mode(value).nil?
    end

    # Whether an acceptance is the last answer: true, false, or both may be.
    def finals(value)
      return [true] unless arms?(value)

      always_arms?(value) ? [false] : [true, false]
    end

    # Nothing is known of the kind of a command of none.
    def none?(value)
      value.code.zero?
    end

    def of(value)
      refusals = refused(value).map { |status| Answer.new('REFUSED', status, true) }
      return refusals if none?(value)

      accepted = finals(value).map { |is_final| Answer.new('ACCEPTED', 'OK', is_final) }
      done = arms?(value) ? [Answer.new('DONE', 'OK', true)] : []
      accepted + done + refusals + ended(value).map { |status| Answer.new('ABORTED', status, true) }
    end

    def listed(value, part)
      node = value.more['answers'] or return []
      nodes = node.mapping([], PARTS)
      nodes['ended']&.refuse('is of a command that arms nothing') unless arms?(value)
      nodes[part]&.sequence.to_a.flat_map { |one| one.word == ROBOTS ? of_robots : [one.choice(common)] }
    end

    def common
      @statuses.values.reject(&:robot).select { |status| @model.statuses.of_core?(status) }.map(&:name) - ['OK']
    end

    def of_robots
      @statuses.values.select(&:robot).map(&:name)
    end

    def of_column(key)
      @statuses.values.select { |status| status.more.key?(key) && yield(status.more[key]) }.map(&:name)
    end

    def in_group?(word, value)
      (!none?(value) || %w[every tabled].include?(word)) && GROUPS.fetch(word).call(self, value)
    end

    # In the order of the codes. A status that stands in a row needs no word of it in its columns, and the other way around.
    def sum(value, part, of_columns)
      listed = listed(value, part)
      twice = (listed & of_columns).first
      value.more['answers'].refuse("names #{twice} under #{part}, which its columns in status.yml add") if twice
      in_order(listed + of_columns)
    end

    def in_order(names)
      @statuses.values.map(&:name) & names
    end

    def header
      C.file(SAYS, FROM) + C.guard('answer_list', <<~CODE)
        #include "interface/answer.h"

        #include <stddef.h>
        #include <stdint.h>

        /** One answer that a command may get. */
        typedef struct {
            uint32_t command;  /**< command_kind_t. */
            uint32_t kind;     /**< answer_kind_t. */
            uint32_t status;   /**< status_t. */
            uint32_t is_final; /**< 1: no further answer follows. */
        } answer_row_t;

        /** All of them. */
        extern const answer_row_t answer_rows[];
        extern const size_t answer_row_count;

        /** The place of an answer among the rows, a command of an unknown kind counted as none; answer_row_count: it is not
         * among them. */
        size_t answer_row_of(const answer_t *answer);
      CODE
    end

    def source
      rows = to_a.flat_map { |value, answers| answers.map { |one| "    {#{row(value, one)}},\n" } }
      <<~CODE
        #{C.file(SAYS, FROM).chomp}
        #include "answer_list.h"

        const answer_row_t answer_rows[] = {
        #{rows.join}};

        const size_t answer_row_count = sizeof answer_rows / sizeof answer_rows[0];

        size_t answer_row_of(const answer_t *answer)
        {
            const uint32_t command = (answer->command < COMMAND_KIND_COUNT) ? answer->command : (uint32_t)#{@kinds.constant(@kinds.values.first)};
            size_t place = 0U;
            while ((place < answer_row_count) &&
                   ((answer_rows[place].command != command) || (answer_rows[place].kind != answer->kind) ||
                    (answer_rows[place].status != answer->status) || (answer_rows[place].is_final != answer->is_final))) {
                place++;
            }
            return place;
        }
      CODE
    end

    def row(value, answer)
      ["(uint32_t)#{@kinds.constant(value)}", "(uint32_t)#{@model.enumeration(KIND).prefix}_#{answer.kind}",
       "(uint32_t)#{@statuses.prefix}_#{answer.status}", answer.is_final ? '1U' : '0U'].join(', ')
    end
  end
end
