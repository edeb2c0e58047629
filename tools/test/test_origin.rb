# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# The rule under test: the id of a tree distinguishes every content from every other, and nothing else changes it.

require 'fileutils'
require 'minitest/autorun'
require 'open3'
require 'tmpdir'
require_relative '../origin'

class TestOrigin < Minitest::Test
  def test_SWR_TRACE_002_a_clean_checkout_has_the_tree_of_its_commit
    in_checkout do |root|
      origin = Origin.here(root)
      assert_equal git(root, 'rev-parse', 'HEAD', 'HEAD^{tree}').split, origin.values_at('commit', 'tree')
      refute origin['is_changed']
    end
  end

  def test_SWR_TRACE_002_every_change_of_content_gives_another_tree
    { 'changed' => ->(root) { File.write("#{root}/a.c", 'int b;') },
      'new' => ->(root) { File.write("#{root}/b.c", '') },
      'staged' => ->(root) { File.write("#{root}/b.c", '') && git(root, 'add', 'b.c') },
      'gone' => ->(root) { File.delete("#{root}/a.c") },
      'renamed' => ->(root) { File.rename("#{root}/a.c", "#{root}/b.c") },
      'executable' => ->(root) { File.chmod(0o755, "#{root}/a.c") } }.each do |what, change|
      in_checkout do |root|
        change.call(root)
        origin = Origin.here(root)
        refute_equal git(root, 'rev-parse', 'HEAD^{tree}'), origin['tree'], what
        assert origin['is_changed'], what
      end
    end
  end

  def test_SWR_TRACE_002_what_git_ignores_and_what_git_keeps_for_itself_change_nothing
    in_checkout do |root|
      before = Origin.tree(root)
      FileUtils.mkdir_p("#{root}/build")
      File.write("#{root}/build/results.json", '{}')
      kept = Dir.glob('.git/**/*', base: root)
      assert_equal before, Origin.tree(root)
      assert_equal kept, Dir.glob('.git/**/*', base: root)
    end
  end

  def test_SWR_TRACE_002_an_exported_tree_has_the_same_id_and_no_commit
    in_checkout do |root|
      tree = Origin.tree(root)
      FileUtils.mkdir_p("#{root}/inside/export")
      git(root, 'checkout-index', '--all', '--prefix=inside/export/')
      origin = Origin.here("#{root}/inside/export")
      assert_equal [nil, tree, nil], origin.values_at('commit', 'tree', 'is_changed')
    end
  end

  def test_SWR_TRACE_002_another_folder_is_another_checkout
    in_checkout do |root|
      Dir.mktmpdir { |other| refute_equal Origin.checkout(root), Origin.checkout(other) }
      assert_equal Origin.checkout(root), Dir.chdir(root) { Origin.checkout }
    end
  end

  def test_SWR_TRACE_002_names_machine_and_tools
    origin = in_checkout { |root| Origin.here(root) }
    assert_equal RUBY_VERSION, origin['tools']['ruby']
    assert_match(/\A\d+\.\d+/, origin['tools']['gcc'])
    assert_equal Etc.nprocessors, origin['machine']['cores']
    assert_empty(origin['machine'].select { |_what, said| said.to_s.strip.empty? })
  end

  private

  def in_checkout
    Dir.mktmpdir do |root|
      File.write("#{root}/a.c", "int a;\n")
      File.write("#{root}/.gitignore", "/build/\n")
      git(root, 'init', '--quiet')
      git(root, 'add', '--all')
      git(root, '-c', 'user.name=a', '-c', 'user.email=a@b', 'commit', '--quiet', '--message', 'Begin')
      yield root
    end
  end

  def git(root, *arguments)
    output, status = Open3.capture2e(Origin::GIT, 'git', '-C', root, *arguments)
    assert status.success?, output
    output.strip
  end
end
