# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0

require_relative 'check/static_checks'
require_relative 'check/walk_checks'
require_relative 'emit/c/header'
require_relative 'emit/c/source'
require_relative 'emit/driver'
require_relative 'emit/tests/paths_test'
require_relative 'emit/tests/walk_test'
require_relative 'emit/vector'
require_relative 'read/parser'
require_relative 'walk/walk'

module Chart
  # A chart with its walk, and what is made of both.
  Compiled = Struct.new(:document, :walk) do
    # A chart that passes every rule. owners: whose each limit is, name => id of a requirement; nil where nobody knows.
    def self.from(file, text, limits, mode: :product, extra_events: [], owners: nil)
      of(Parser.parse(file, text, limits, mode: mode, extra_events: extra_events), owners)
    end

    # The same of a document. forgiven: numbers of rules that do not refuse it.
    def self.of(document, owners, forgiven: [])
      checked(forgiven) { StaticChecks.run(document, owners) }
      walk = Walk.new(document).run
      checked(forgiven) { WalkChecks.run(document, walk) }
      new(document, walk)
    end

    # What a chart says, whether or not it may be compiled; without a walk where it cannot be walked.
    def self.leniently(file, text, limits)
      document = Parser.parse(file, text, limits, mode: :difference)
      new(document, walked(document))
    end

    def self.walked(document)
      StaticChecks.run(document)
      Walk.new(document).run
    rescue Refusal
      nil
    end

    def self.checked(forgiven)
      yield
    rescue Refusal => e
      raise unless forgiven.include?(e.rule)
    end
    private_class_method :walked, :checked

    # NAME_chart.h.
    def header
      C::Header.new(document, walk).emit
    end

    # NAME_chart.c.
    def source
      C::Source.new(document, walk).emit
    end

    # The shape of its code, :direct or :staged.
    def shape
      C::Source.shape(document)
    end

    # Name of a file => header and source.
    def files
      { "#{document.name}_chart.h" => header, "#{document.name}_chart.c" => source }
    end

    # Name of a file => a Unity test of the code: of every pair of the walk, and of every path from the start. proves: what
    # tests of each kind of Proves stand for, kind => id of a requirement.
    def tests(proves: {})
      { "test_#{document.name}_walk.c" => WalkTest.new(document, walk, proves).emit,
        "test_#{document.name}_paths.c" => PathsTest.new(document, walk).emit }
    end

    # A program that runs the code by line commands.
    def driver
      Driver.new(document, walk).emit
    end

    # What the code calls things.
    def names
      C::Parts.new(document, walk).names
    end

    # A configuration as the numbers that the code stores.
    def vector
      Vector.new(document)
    end

    # Its size in one line.
    def words
      format('%-15<name>s %3<reached>d configurations, %6<pairs>d pairs', name: document.name, reached: walk.reached.length,
                                                                          pairs: walk.pair_count)
    end
  end
end
