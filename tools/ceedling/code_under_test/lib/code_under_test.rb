# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'ceedling/plugins/plugin'
require 'fileutils'

# Links the code under test into every test: core with its charts and robots, boards and processes. make has compiled
# it before, once for all tests and as strictly as the product. Sources that a test brings itself go before: mocks, or a
# source that it includes. A source that is the same in all tests is compiled for the first of them.
class CodeUnderTest < Plugin
  # By Ceedling's way to run the tests. With coverage, core and charts are counted; around them is the product's own code.
  LIBRARIES = { test: %w[build/gcc/libtest.a], gcov: %w[build/gcov/libcore.a build/gcc/libaround.a] }.freeze
  SAME = %r{/(?:vendor/\w+/src|support)/\w+\.c\z}
  # Nothing of the core is in them: they are not counted.
  GENERATED = %r{_runner\.c\z|/mock_\w+\.c\z}
  # Code of the core's headers that these call is counted too.
  COUNTED = { test: [], gcov: %w[--coverage] }.freeze

  def setup
    @objects = {}
    @lock = Mutex.new
  end

  # Ceedling's hook, before it builds a test; it does not see that a library has changed.
  def pre_test(test)
    LIBRARIES.each do |context, libraries|
      programs = Dir["build/ceedling/#{context}/out/**/#{File.basename(test, '.c')}.out"]
      there = libraries.all? { |library| File.exist?(library) }
      FileUtils.rm_f(programs.reject { |program| there && FileUtils.uptodate?(program, libraries) })
    end
  end

  # Ceedling's hook, before it compiles a source of a test.
  def pre_compile_execute(arguments)
    arguments[:tool] = TOOLS_TEST_COMPILER if arguments[:source].match?(GENERATED)
    return unless arguments[:source].match?(SAME)

    object = @lock.synchronize { @objects[arguments[:source]] ||= compile(arguments) }
    arguments.merge!(tool: { name: +'cp', executable: +'cp', arguments: [+object, +'"${2}"'] }, flags: [])
  end

  # Ceedling's hook, before it links a test.
  def pre_link_execute(arguments)
    arguments[:objects] += ['-Wl,--start-group', *LIBRARIES.fetch(arguments[:context]), '-Wl,--end-group']
  end

  private

  def compile(arguments)
    folder = "build/ceedling/#{arguments[:context]}/same"
    object = "#{folder}/#{File.basename(arguments[:source], '.c')}.o"
    FileUtils.mkdir_p(folder)
    options = arguments[:defines].map { |define| "-D#{define}" } + arguments[:search_paths].map { |path| "-I#{path}" }
    system('gcc', *arguments[:flags], *COUNTED.fetch(arguments[:context]), *options, '-c', arguments[:source], '-o', object, exception: true)
    object
  end
end
