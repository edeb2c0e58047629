# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

module Gates
  # Environment of a gate that lends its compilers a cache of objects, if ccache is installed. The key of an object is the compiler, its
  # options and every byte that it reads; the bytes of the object are those of the compiler, wherever the clone lies.
  #
  # @satisfies SWR-GATE-360
  module CompilerCache
    PROGRAM = 'ccache'
    # Outside of build/: `make clean` leaves it.
    FOLDER = '.tools/ccache'
    SIZE = '3G'

    def self.environment(path = ENV.fetch('PATH'))
      return {} unless path.split(':').any? { |folder| File.executable?(File.join(folder, PROGRAM)) }

      { 'COMPILER_CACHE' => PROGRAM, 'CCACHE_DIR' => File.expand_path(FOLDER), 'CCACHE_MAXSIZE' => SIZE }
    end
  end
end
