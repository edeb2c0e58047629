#!/usr/bin/env ruby
# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Looks up what docs/thesis.md names: that each listing, figure, table, mode and test of the thesis has its row, and that
# there is whatever stands in backticks there.
#
#   ruby tools/thesis_page.rb      one line for each that is not so, exit 1 if there is any

require 'yaml'
require_relative 'trace/sources'

# The page with its tables of three columns: what the thesis has, what Boresight has, and the command that shows it, or `-`.
class ThesisPage
  PAGE = 'docs/thesis.md'
  ROBOT_TESTS = %w[CheckForStalls ValidateForwardKinematics RunInverseKinematics IsFootPedalPressed ListMotors GetMotor].freeze
  OWED = [*(1..17).map { |number| "Listing #{number}" }, *(1..38).map { |number| "Figure #{number}" }, 'Table 1', 'Table 2',
          *['Manual', 'Home', 'Trajectory', 'Frequency Sweep', 'Cooperative Biopsy'].map { |mode| "Mode #{mode}" },
          *%w[NeuroRobot ProstateRobot].product(ROBOT_TESTS).map { |names| "Test #{names.join('_')}" },
          *%w[Motor_GetMinTicksGetMaxTicks Encoder_SetPosition Logger_SetLogLevel Packets_Connection].map { |name| "Test #{name}" }].freeze
  C_TESTS = '{verification/unit,verification/integration,core/robot/*/test}'
  RUBY_TESTS = '{tools/test,verification/**}'

  def initialize(root, text = File.read(File.join(root, PAGE), encoding: 'UTF-8'), sources: Trace::Sources.new(root))
    @root = root
    @sources = sources
    @rows = text.lines.each.with_index(1).filter_map { |line, number| row(line, number) }
    @text = text
  end

  # @satisfies SWR-THESIS-001
  def complaints
    missing + @rows.flat_map { |row| of_row(row) } + unknown
  end

  private

  Row = Struct.new(:line, :cells) do
    def names
      cells.last.scan(/`([^`]+)`/).flatten
    end
  end

  def row(line, number)
    return unless line.start_with?('| ') && !line.match?(/\A\| (---|Thesis )/)

    Row.new(number, line.strip.delete_prefix('|').delete_suffix('|').split('|').map(&:strip))
  end

  # `Figures 18 to 23` and `Figures 1, 2` are as many.
  def told
    @rows.flat_map do |row|
      kind, numbers = row.cells.first.match(/\A(Figure|Listing|Table)s? ([\d, to]+)/)&.captures
      next row.cells.first[/\A(Mode|Test) [^:]+/] unless kind

      numbers.split(',').flat_map { |part| Range.new(*part.scan(/\d+/).map(&:to_i).minmax).to_a }.map { |number| "#{kind} #{number}" }
    end
  end

  def missing
    told = self.told
    OWED.reject { |name| told.include?(name) }.map { |name| "#{PAGE}: #{name} has no row" } +
      told.compact.tally.filter_map { |name, count| "#{PAGE}: #{name} has #{count} rows" if count > 1 }
  end

  def of_row(row)
    return [complaint(row.line, 'a row has three cells, and none is empty')] if row.cells.size != 3 || row.cells.any?(&:empty?)
    return [complaint(row.line, 'a command, or - and nothing else')] if row.names.empty? && row.cells.last != '-'

    file = row.names.filter_map { |name| test_file(name[/\Amake one NAME=(\w+)\z/, 1].to_s) }
    tests = file.empty? ? [] : row.names.grep(/\Atest_SWR/).reject { |test| tests_of(file).include?(test) }
    tests.map { |test| complaint(row.line, "#{test} is not in #{file.join(', ')}") }
  end

  def unknown
    @text.lines.each.with_index(1).flat_map do |line, number|
      line.scan(/`([^`]+)`/).flatten.filter_map { |name| complaint(number, "there is no #{name}") unless there?(name) }
    end
  end

  def complaint(line, reason)
    "#{PAGE}:#{line}: #{reason}"
  end

  def there?(name)
    case name
    when /\A(?:ROBOT=(\w+) )?make ([\w-]+)((?: [A-Z]+=\S+)*)\z/ then command?(*Regexp.last_match.captures)
    when /\Atest_SWR_/ then @sources.tests.any? { |test| test.name == name }
    when /\A(GET|PUT|POST|DELETE) (\S+)\z/ then routes.include?([Regexp.last_match(1), Regexp.last_match(2)])
    when %r{\Acurl http://127\.0\.0\.1:8080(/\S+)\z} then routes.include?(['GET', Regexp.last_match(1)])
    when %r{\Abuild/bin/([\w-]+)} then makefiles.match?(/(PROGRAMS|SOURCES_)\S*.*\b#{Regexp.last_match(1)}\b/)
    when /\ASWR-/ then requirements.include?(name)
    when /\A[A-Z][A-Z_]+\z/ then interface.match?(/\bname: #{name}\b/)
    when %r{\A[\w./-]+\z} then File.exist?(File.join(@root, name))
    end
  end

  def command?(robot, target, settings)
    settings = settings.split.to_h { |setting| setting.split('=') }
    robot ||= settings['ROBOT']
    return false unless makefiles.match?(/^#{target}:.* ## /) && (robot.nil? || File.directory?("#{@root}/core/robot/#{robot}"))

    case target
    when 'one' then !test_file(settings['NAME']).nil?
    when 'gate' then gates.include?(settings['NAME'])
    else settings['FILE'].nil? || File.exist?(File.join(@root, settings['FILE']))
    end
  end

  # What `make one` runs.
  def test_file(name)
    Dir.glob(["#{C_TESTS}/#{name}.c", "#{RUBY_TESTS}/#{name}.rb"], base: @root).min
  end

  def tests_of(files)
    @sources.tests.select { |test| files.include?(test.place.file) }.map(&:name)
  end

  def requirements
    @requirements ||= Trace::Requirements.load('requirements', @root).items.map(&:id)
  end

  def gates
    @gates ||= YAML.safe_load_file("#{@root}/verification/gates.yml").map { |gate| gate['name'] }
  end

  def routes
    @routes ||= YAML.safe_load_file("#{@root}/core/interface/routes.yml").fetch('routes').map do |route|
      [route.fetch('method', 'GET').upcase, route.fetch('path')]
    end
  end

  def makefiles
    @makefiles ||= texts('{Makefile,bsp/*/board.mk,verification/*.mk,verification/*/*.mk}')
  end

  def interface
    @interface ||= texts('core/interface/*.yml')
  end

  def texts(pattern)
    Dir.glob(pattern, base: @root).sort.map { |file| File.read(File.join(@root, file), encoding: 'UTF-8') }.join
  end
end

if $PROGRAM_NAME == __FILE__
  complaints = ThesisPage.new(File.expand_path('..', __dir__)).complaints
  puts complaints
  exit complaints.empty?
end
