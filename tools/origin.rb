# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'digest'
require 'etc'
require 'json'
require 'open3'
require 'socket'
require 'time'
require 'tmpdir'

# Where a test result comes from: which content of the working tree, which checkout on which machine, which tools.
module Origin
  TOOLS = %w[gcc clang clang-19 arm-linux-gnueabihf-gcc ccache qemu-arm ruby node cppcheck frama-c z3 gcovr spin valgrind chromium].freeze
  # No other repository than the one that is meant, also below a hook of git.
  GIT = { 'GIT_DIR' => nil, 'GIT_WORK_TREE' => nil, 'GIT_INDEX_FILE' => nil }.freeze
  # `make test` says it once for all its gates, as the tree was before the first began.
  ENVIRONMENT = 'BORESIGHT_ORIGIN'

  class << self
    # The origin of results that are made now.
    def of_run
      ENV.key?(ENVIRONMENT) ? JSON.parse(ENV.fetch(ENVIRONMENT)) : here
    end

    def here(root = '.')
      commit, commit_tree = commit(root)
      tree = tree(root)
      { 'commit' => commit, 'tree' => tree, 'is_changed' => commit && tree != commit_tree,
        'checkout' => checkout(root), 'machine' => machine, 'tools' => tools }
    end

    # The id that git gives to the content of the working tree: all files but the ignored ones. It needs no repository,
    # so an exported source has the same one as the commit that it was exported from.
    def tree(root = '.')
      Dir.mktmpdir do |folder|
        git = [*%w[core.excludesFile=/dev/null core.autocrlf=false core.compression=0].flat_map { |set| ['-c', set] },
               "--git-dir=#{folder}/git", '--work-tree=.']
        git(root, *git, 'init', '--quiet', '--template=')
        git(root, *git, 'add', '--all')
        git(root, *git, 'write-tree') || raise("git could not read #{File.realpath(root)}")
      end
    end

    # Distinguishes this folder on this machine from any other.
    def checkout(root = '.')
      machine = File.exist?('/etc/machine-id') ? File.read('/etc/machine-id') : ''
      Digest::SHA256.hexdigest([machine, Socket.gethostname, File.realpath(root)].join("\0"))[0, 12]
    end

    # In words.
    def tree_of(run)
      commit = run['commit'] ? "commit #{run['commit'][0, 12]}#{' with changes' if run['is_changed']}, " : ''
      "#{commit}tree #{run['tree'][0, 12]}"
    end

    def machine_of(run)
      processor, cores, kernel, system = run['machine'].to_h.values_at('processor', 'cores', 'kernel', 'system')
      "#{processor || 'unknown'}, #{cores} cores, #{kernel}, #{system}"
    end

    private

    # The commit and its tree; nothing without a repository of its own.
    def commit(root)
      return [nil, nil] unless git(root, 'rev-parse', '--show-prefix') == ''

      git(root, 'rev-parse', 'HEAD', 'HEAD^{tree}')&.split || [nil, nil]
    end

    # Output of git, or nil if it refuses.
    def git(root, *arguments)
      output, status = Open3.capture2(GIT, 'git', '-C', root, *arguments, err: File::NULL)
      output.strip if status.success?
    end

    def machine
      uname = Etc.uname
      { 'processor' => "#{File.read('/proc/cpuinfo')[/^model name\s*:\s*(.*)/, 1]} (#{uname[:machine]})",
        'cores' => Etc.nprocessors, 'kernel' => "#{uname[:sysname]} #{uname[:release]}",
        'system' => File.read('/etc/os-release')[/^PRETTY_NAME="?(.*?)"?$/, 1] }
    end

    # The first number that each tool says of itself; one that is not installed is left out.
    def tools
      found = TOOLS.to_h { |tool| [tool, said_by(tool)] }
      gems = File.readlines(File.expand_path('gems.lock', __dir__), chomp: true).grep_v(/\A#/).to_h(&:split)
      found.merge('ceedling' => gems['ceedling']).compact
    end

    def said_by(tool)
      output, = Open3.capture2e(tool, tool == 'spin' ? '-V' : '--version')
      output[/\d+(?:\.\d+)+/]
    rescue Errno::ENOENT
      nil
    end
  end
end
