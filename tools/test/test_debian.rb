# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: an apt of our own asks whom this computer asks, for the release itself and its main part.

require 'minitest/autorun'
require_relative '../debian/apt_sources'

class TestDebian < Minitest::Test
  BOTH = %w[deb deb-src].freeze

  def test_SWR_ARM_001_a_line_keeps_its_options_but_the_architectures
    lines = <<~LIST
      # deb http://old.example/debian sid main
      deb [arch=amd64,i386 signed-by=/usr/share/keyrings/a.gpg] http://mirror.example/debian sid main contrib
      deb http://mirror.example/debian sid-updates main
      deb-src http://mirror.example/debian sid main
      deb http://other.example/apt other-sid main
      deb http://mirror.example/debian sid contrib
    LIST
    assert_equal <<~LIST, AptSources.lines(lines, 'sid', BOTH)
      deb [signed-by=/usr/share/keyrings/a.gpg] http://mirror.example/debian sid main
      deb-src [signed-by=/usr/share/keyrings/a.gpg] http://mirror.example/debian sid main
    LIST
  end

  def test_SWR_ARM_001_a_line_without_options_stays_without
    assert_equal "deb http://m.example sid main\ndeb-src http://m.example sid main\n",
                 AptSources.lines("deb\thttp://m.example  sid   main non-free # ours\n", 'sid', BOTH)
  end

  def test_SWR_ARM_001_a_stanza_keeps_its_fields_but_the_architectures
    stanza = <<~SOURCES
      Types: deb
      # the nearest
      URIs: http://mirror.example/debian
      Suites: sid sid-updates
      Components: main contrib
      Architectures: amd64
      Signed-By: /usr/share/keyrings/a.gpg
    SOURCES
    assert_equal <<~SOURCES, AptSources.stanzas(stanza, 'sid', BOTH)
      Types: deb deb-src
      Suites: sid
      Components: main
      # the nearest
      URIs: http://mirror.example/debian
      Signed-By: /usr/share/keyrings/a.gpg
    SOURCES
  end

  def test_SWR_ARM_001_other_stanzas_are_left_out
    { 'Suites' => 'sid-security', 'Types' => 'deb-src', 'Components' => 'contrib', 'Enabled' => 'no' }.each do |field, value|
      fields = { 'Types' => 'deb', 'URIs' => 'http://m.example', 'Suites' => 'sid', 'Components' => 'main' }
      stanza = fields.merge(field => value).map { |pair| "#{pair.join(': ')}\n" }.join
      assert_empty AptSources.stanzas("#{stanza}\n", 'sid', BOTH), field
    end
  end

  def test_SWR_ARM_001_stanzas_are_distinguished
    stanza = "Types: deb\nURIs: http://m.example\nSuites: sid\nComponents: main\n"
    assert_equal 2, AptSources.stanzas("#{stanza}\n\n#{stanza}", 'sid', BOTH).scan(/^Types:/).size
  end

  def test_SWR_TOOL_200_another_release_is_asked_for_where_this_one_comes_from
    assert_equal "deb http://m.example next main\n", AptSources.lines('deb http://m.example sid main', 'sid', ['deb'], 'next')
    stanza = "Types: deb\nURIs: http://m.example\nSuites: sid sid-updates\nComponents: main\n"
    assert_equal "Types: deb\nSuites: next\nComponents: main\nURIs: http://m.example\n", AptSources.stanzas(stanza, 'sid', ['deb'], 'next')
  end

  def test_SWR_ARM_001_who_wants_sources_alone_asks_for_no_packages
    assert_equal "deb-src http://m.example sid main\n", AptSources.lines('deb http://m.example sid main', 'sid', ['deb-src'])
  end
end
