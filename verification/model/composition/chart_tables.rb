# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

# One chart in a composition: its configurations, its compiled code as a step from number to number, and the
# interpreter's table of the same. Stimuli are numbered: events, then timers.
class ChartTables
  def initialize(chart)
    @document = chart.document
    @walk = chart.walk
    @name = @document.name
    @names = chart.names
    @vector = chart.vector
    @numbers = @walk.reached.keys.each_with_index.to_h
    @cells = {}.compare_by_identity
    @pairs = @walk.reachable_pairs.to_h { |pair| [[pair.before, pair.stimulus], pair] }
  end

  def emit
    [compiled, table].join("\n")
  end

  # C that reads the number of a configuration from the chart's own fields.
  def numbers
    [vectors, number].join("\n")
  end

  private

  def vectors
    rows = @numbers.keys.map { |snapshot| "    {#{@vector.encode(snapshot).join(', ')}},\n" }
    "static const int32_t #{@name}_vectors[][#{@vector.fields.length}] = {\n#{rows.join}};\n"
  end

  def compiled
    <<~TEXT
      static uint32_t #{@name}_compiled(uint32_t own, uint32_t event, uint32_t inputs, uint32_t *actions)
      {
          const int32_t *const vector = #{@name}_vectors[own];
          #{@names.chart_type} chart;
      #{levels}    (void)inputs;
          #{@names.chart_function('init')}(&chart);
      #{load}    switch (event) {
      #{expiries}    default:
              *actions = #{call('dispatch', "(#{@names.event_type})event")};
              break;
          }
          return #{@name}_number(&chart);
      }
    TEXT
  end

  def number
    <<~TEXT
      static inline uint32_t #{@name}_number(const #{@names.chart_type} *chart)
      {
          for (uint32_t i = 0U; i < #{@numbers.length}U; i++) {
              if (#{same}) {
                  return i;
              }
          }
          return NEVER;
      }
    TEXT
  end

  def call(function, last)
    "#{@names.chart_function(function)}(&chart#{', &levels' if @document.inputs.any?}, #{last})"
  end

  def levels
    values = @document.inputs.each_with_index.map do |input, bit|
      ".#{@names.field(input.name)} = ((inputs >> #{bit}U) & 1U) != 0U"
    end
    values.empty? ? '' : "    const #{@names.inputs_type} levels = {#{values.join(', ')}};\n"
  end

  def load
    @vector.fields.each_with_index.map do |field, place|
      value = field.type == 'bool' ? "vector[#{place}] != 0" : "(#{field.type})vector[#{place}]"
      inverse = "    chart.#{@names.inverse(field.part)} = ~(uint32_t)chart.#{field.name};\n" if field.kind == :region
      "    chart.#{field.name} = #{value};\n#{inverse}"
    end.join
  end

  # The timer has run for all but one tick.
  def expiries
    tick = @document.tick_us
    @document.timers.each_with_index.map do |timer, index|
      <<~TEXT.gsub(/^/, '    ')
        case #{@document.events.length + index}U:
            if (!chart.#{@names.armed(timer)}) {
                return NEVER;
            }
            chart.#{@names.time(timer)} = #{[timer.threshold_us - tick, 0].max}U;
            *actions = #{call('advance', "#{tick}U")};
            break;
      TEXT
    end.join
  end

  def same
    @vector.fields.each_with_index.map do |field, place|
      "chart->#{field.name} == (#{field.type})#{@name}_vectors[i][#{place}]"
    end.join(' && ')
  end

  def table
    stimuli = @document.events.map { |event| [:event, event] } + @document.timers.map { |timer| [:expire, [timer.id]] }
    rows = @numbers.keys.map { |snapshot| "    {\n#{stimuli.map { |one| cells(snapshot, one) }.join}    },\n" }
    <<~TEXT
      static const answer_t #{@name}_answers[][#{stimuli.length}][#{@walk.valuations.length}] = {
      #{rows.join}};

      static uint32_t #{@name}_interpreted(uint32_t own, uint32_t event, uint32_t inputs, uint32_t *actions)
      {
          *actions = #{@name}_answers[own][event][inputs].actions;
          return #{@name}_answers[own][event][inputs].after;
      }
    TEXT
  end

  def cells(snapshot, stimulus)
    pair = @pairs[[snapshot, stimulus]]
    outcomes = pair ? pair.outcomes : [nil] * @walk.valuations.length
    "        {#{outcomes.map { |outcome| cell(outcome) }.join(', ')}},\n"
  end

  # One outcome stands for all valuations that it does not read.
  def cell(outcome)
    return '{NEVER, 0U}' unless outcome

    @cells[outcome] ||= begin
      actions = outcome.actions.sum { |action| 1 << @document.actions.index(action) }
      "{#{@numbers.fetch(outcome.after)}U, #{actions}U}"
    end
  end
end
