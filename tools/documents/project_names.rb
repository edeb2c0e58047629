# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'yaml'
require_relative '../interface/model'
require_relative '../trace/sources'

# Names that documents may use: commands, tests, routes, programs, requirements, files, functions and words of the sources.
class ProjectNames
  C_TESTS = '{verification/unit/*,verification/integration/*,core/robot/*/test}'
  RUBY_TESTS = '{tools/test/**,verification/**}'
  SOURCES = '{core,bsp,app,site,statecharts,requirements,verification,tools}/**/*.{h,c,rb,ts,tsx,mk,yml,scxml}'
  LEFT_OUT = %r{node_modules/|/dist/}

  attr_reader :root

  def initialize(root, sources: Trace::Sources.new(root))
    @root = root
    @sources = sources
  end

  def there?(name)
    case name
    when /\A(?:ROBOT=(\w+) )?make ([\w-]+)((?: [A-Z]+=\S+)*)\z/ then command?(*Regexp.last_match.captures)
    when /\Atest_[A-Z]+_/ then @sources.tests.any? { |test| test.name == name }
    when /\A(GET|PUT|POST|DELETE) (\S+)\z/ then routes.include?([Regexp.last_match(1), Regexp.last_match(2)])
    when %r{\Acurl http://127\.0\.0\.1:8080(/\S+)\z} then routes.include?(['GET', Regexp.last_match(1)])
    when %r{\Abuild/bin/([\w-]+)} then makefiles.match?(/(PROGRAMS|SOURCES_)\S*.*\b#{Regexp.last_match(1)}\b/)
    when /\A(?:SWR|HAZ|RC|LIM)-/ then requirements.include?(name)
    when /\A[A-Z][A-Z_]+\z/ then interface.match?(/\bname: #{name}\b/)
    when %r{\A[\w./-]+\z} then File.exist?(File.join(root, name))
    end
  end

  # As `there?`, or a word, call or path that the sources hold: what prose may quote of them.
  def quoted?(text)
    return there?(text) if text.match?(/\A(?:make |test_[A-Z]|(?:SWR|HAZ|RC|LIM)-)/)

    there?(text) || text.scan(/[\w.\/@-]*\w/).all? { |word| there?(word) || words.match?(/#{'\b' if word.match?(/\A[a-z0-9]/i)}#{Regexp.escape(word)}\b/) }
  end

  # Test file that `make one` runs.
  def test_file(name)
    Dir.glob(["#{C_TESTS}/#{name}.c", "#{RUBY_TESTS}/#{name}.rb"], base: root).min
  end

  def tests_of(files)
    @sources.tests.select { |test| files.include?(test.place.file) }.map(&:name)
  end

  private

  def command?(robot, target, settings)
    settings = settings.split.to_h { |setting| setting.split('=') }
    robot ||= settings['ROBOT']
    return false unless makefiles.match?(/^(?:[\w.-]+ )*#{target}(?: [\w.-]+)*:(?!=)/) && (robot.nil? || File.directory?("#{root}/core/robot/#{robot}"))

    case target
    when 'one' then !test_file(settings['NAME']).nil?
    when 'gate' then gates.include?(settings['NAME'])
    else settings['FILE'].nil? || File.exist?(File.join(root, settings['FILE']))
    end
  end

  def requirements
    @requirements ||= Trace::Requirements.load('requirements', root).items.map(&:id)
  end

  def gates
    @gates ||= YAML.safe_load_file("#{root}/verification/gates.yml").map { |gate| gate['name'] }
  end

  def routes
    @routes ||= Interface::Model.new("#{root}/core/interface").routes.routes.map { |route| [route.method, route.path] }
  end

  def makefiles
    @makefiles ||= texts('{Makefile,app/*/sources.mk,bsp/*/board.mk,site/*.mk,verification/*.mk,verification/*/*.mk}')
  end

  def interface
    @interface ||= texts('core/interface/*.yml')
  end

  def words
    @words ||= makefiles + texts(SOURCES)
  end

  def texts(pattern)
    Dir.glob(pattern, base: root).grep_v(LEFT_OUT).sort.map { |file| File.read(File.join(root, file), encoding: 'UTF-8') }.join
  end
end
