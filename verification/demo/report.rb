# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'

# Table and pictures of what a robot's demonstration reached.
class DemoReport
  class << self
    def gnuplot(script, settings)
      text = settings.map { |name, value| "#{name}=#{value.is_a?(Float) ? value : "'#{value}'"}" }.join('; ')
      system('gnuplot', '-e', text, File.expand_path(script, __dir__)) || raise("gnuplot could not draw #{script}")
    end

    # Motion of one axis, a row each: :time, and its columns without its name.
    def read(csv, axis)
      names, *rows = File.foreach(csv, chomp: true).map { |line| line.split(',') }
      places = names.each_index.select { |place| names[place].start_with?("#{axis}_") }
      keys = places.map { |place| names[place].delete_prefix("#{axis}_").to_sym }
      rows.map { |row| { time: row.first.to_f }.merge(keys.zip(row.values_at(*places).map(&:to_f)).to_h) }
    end

    # The rows of each time in which the speed of the set-point is not 0.
    def moves(rows)
      parts = rows.slice_when { |a, b| a[:setpoint_ticks_per_s].zero? != b[:setpoint_ticks_per_s].zero? }
      parts.reject { |part| part.first[:setpoint_ticks_per_s].zero? }
    end
  end

  def initialize(robot, rows, out)
    @robot = robot
    @rows = rows
    @out = out
  end

  def print_table(note)
    puts format("\n%-3s %-28s %-28s %10s %11s %9s", 'No', 'target (RAS, mm)', 'reached (RAS, mm)', 'error, mm', 'thesis, mm',
                'move, s')
    @rows.each { |row| print_row(row) }
    puts format("%-61s %10.4f %s\n\n", 'mean', mean(:error_mm), thesis(mean(:thesis_mm)))
    puts "#{note}\n\n" if note
  end

  # targets.json; points.csv for `make points`; motion.png from motion.csv; and of `close_up`, if there is one, NAME.png.
  def leave(csv, close_up)
    File.write(File.join(@out, 'targets.json'), "#{JSON.pretty_generate(@rows)}\n")
    leave_points
    names = columns(csv).filter_map { |name| name[/(.*)_position_ticks\z/, 1] }
    self.class.gnuplot('motion.gnuplot', source: csv, picture: File.join(@out, 'motion.png'), robot: @robot,
                                         axes: names.join(' '))
    draw_longest_move(csv, close_up) if close_up
  end

  private

  def leave_points
    head = 'target_x,target_y,target_z,measured_x,measured_y,measured_z'
    rows = @rows.map { |row| row.values_at(:target, :reached).flatten.join(',') }
    File.write(File.join(@out, 'points.csv'), [head, *rows, ''].join("\n"))
  end

  def print_row(row)
    puts format('%-3d %-28s %-28s %10.4f %s %9.1f', row[:number], row[:target].join(', '), row[:reached].join(', '),
                row[:error_mm], thesis(row[:thesis_mm]), row[:move_s])
  end

  def thesis(error_mm)
    error_mm ? format('%11.3f', error_mm) : ' ' * 11
  end

  def columns(csv)
    File.foreach(csv, chomp: true).first.split(',')
  end

  # One axis alone, from half a second before its longest move to half a second after.
  def draw_longest_move(csv, axis)
    first, last = self.class.moves(self.class.read(csv, axis)).max_by(&:size).values_at(0, -1).map { |row| row[:time] }
    self.class.gnuplot('axis.gnuplot', source: csv, picture: File.join(@out, "#{axis}.png"), axis: axis, from: first - 0.5,
                                       to: last + 0.5)
  end

  # nil when a row has none.
  def mean(field)
    values = @rows.map { |row| row[field] }
    values.all? ? values.sum / values.size : nil
  end
end
