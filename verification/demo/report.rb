# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'json'

# Table and pictures of what a robot's demonstration reached.
class DemoReport
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
    gnuplot('motion.gnuplot', source: csv, picture: File.join(@out, 'motion.png'), robot: @robot, axes: names.join(' '))
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
    first, last = longest_move(csv, "#{axis}_setpoint_ticks_per_s")
    gnuplot('axis.gnuplot', source: csv, picture: File.join(@out, "#{axis}.png"), axis: axis, from: first - 0.5,
                            to: last + 0.5)
  end

  def gnuplot(script, settings)
    text = settings.map { |name, value| "#{name}=#{value.is_a?(Float) ? value : "'#{value}'"}" }.join('; ')
    system('gnuplot', '-e', text, File.expand_path(script, __dir__)) || raise("gnuplot could not draw #{script}")
  end

  # When the speed of the set-point leaves 0 and is there again, in s.
  def longest_move(csv, column)
    names, *rows = File.foreach(csv, chomp: true).map { |line| line.split(',') }
    place = names.index(column)
    moves = rows.slice_when { |a, b| a[place].to_f.zero? != b[place].to_f.zero? }
    moves.reject { |move| move.first[place].to_f.zero? }.max_by(&:size).values_at(0, -1).map { |row| row.first.to_f }
  end

  # nil when a row has none.
  def mean(field)
    values = @rows.map { |row| row[field] }
    values.all? ? values.sum / values.size : nil
  end
end
