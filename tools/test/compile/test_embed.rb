# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: the console's files stand in the program byte for byte, and only those named after their content
# may be kept by a browser.

require 'fileutils'
require 'minitest/autorun'
require 'stringio'
require 'tmpdir'
require 'zlib'
require_relative '../../compile/embed'
require_relative '../../../app/http/view/chart_names'

class TestEmbed < Minitest::Test
  def embed(files)
    Dir.mktmpdir do |folder|
      files.each do |path, bytes|
        FileUtils.mkdir_p(File.dirname(File.join(folder, path)))
        File.binwrite(File.join(folder, path), bytes)
      end
      Embedding.read(folder).source
    end
  end

  def bytes_of(source, index)
    source[/file_#{index}\[\] = \{\n(.*?)\n\}/m, 1].scan(/\d+/).map(&:to_i).pack('C*')
  end

  def test_SWR_HTTP_001_files_are_embedded_byte_for_byte
    bytes = (0..255).to_a.pack('C*')
    assert_equal bytes, bytes_of(embed('index.html' => bytes), 0)
  end

  def test_SWR_HTTP_001_only_files_named_after_their_content_may_be_kept
    source = embed('index.html' => 'a', 'assets/index-hNuxBWoA.js' => 'b', 'plain.js' => 'c')
    kept = source.lines.grep(/immutable/)
    assert_equal 1, kept.size
    assert_includes kept.first, '"/assets/index-hNuxBWoA.js", "text/javascript; charset=utf-8"'
  end

  def test_SWR_HTTP_001_equal_folders_give_equal_sources
    files = { 'index.html' => 'a', 'assets/b.css' => 'b' }
    assert_equal embed(files), embed(files.to_a.reverse.to_h)
  end

  def test_SWR_HTTP_015_a_file_stands_there_packed_if_that_is_shorter
    source = embed('index.html' => 'a' * 1000, 'b.txt' => 'b')
    packed = source[/packed_1\[\] = \{\n(.*?)\n\}/m, 1].scan(/\d+/).map(&:to_i).pack('C*')
    assert_equal 'a' * 1000, Zlib::GzipReader.new(StringIO.new(packed)).read
    assert_includes source, 'file_1, sizeof(file_1), packed_1, sizeof(packed_1)}'
    assert_includes source, 'file_0, sizeof(file_0), NULL, 0}'
  end

  def test_SWR_HTTP_014_other_bytes_have_another_tag
    tags = %w[a a b].map { |bytes| embed('index.html' => bytes)[/"no-store", "(\h{16})"/, 1] }
    assert_equal tags[0], tags[1]
    refute_equal tags[1], tags[2]
  end

  def test_SWR_HTTP_019_a_file_of_elsewhere_is_served_where_it_is_configured
    Dir.mktmpdir do |folder|
      File.write(File.join(folder, 'index.html'), 'a')
      File.write(File.join(folder, '../of.json'), '{}')
      source = Embedding.read(folder, '/api/of.json' => File.join(folder, '../of.json')).source
      assert_includes source, '{"/api/of.json", "application/json", "no-cache"'
    ensure
      FileUtils.rm_f(File.join(folder, '../of.json'))
    end
  end

  def test_SWR_HTTP_001_a_file_of_unknown_kind_is_an_error
    error = assert_raises(ArgumentError) { embed('index.html' => 'a', 'b.exe' => 'b') }
    assert_includes error.message, 'b.exe'
  end

  def test_SWR_HTTP_001_a_console_without_page_is_an_error
    assert_raises(ArgumentError) { embed('a.css' => 'b') }
  end

  def test_SWR_HTTP_001_state_names_stand_at_their_values
    leaves = [{ 'id' => 'late', 'value' => 1 }, { 'id' => 'live', 'value' => 0 }]
    names = ChartNames.new([{ 'name' => 'link', 'regions' => [{ 'name' => 'state', 'leaves' => leaves }] }])
    assert_includes names.source, '{"live", "late"}'
    assert_includes names.header, 'const char *chart_link_state_name(uint32_t state);'
  end

  def test_SWR_HTTP_001_a_gap_in_the_values_is_an_error
    leaves = [{ 'id' => 'live', 'value' => 0 }, { 'id' => 'late', 'value' => 2 }]
    assert_raises(ArgumentError) do
      ChartNames.new([{ 'name' => 'link', 'regions' => [{ 'name' => 'state', 'leaves' => leaves }] }])
    end
  end
end
