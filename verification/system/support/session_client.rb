# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require 'net/http'
require 'open3'
require_relative 'boresight'

# The file of accounts, made by the program for it; and a client that keeps its cookie and its token.
module Accounts
  PASSWORDS = { 'olga' => %w[observer watch-closely], 'anna' => %w[operator correct-horse],
                'egon' => %w[engineer battery-staple] }.freeze

  def self.passwd(file, *words, input: '')
    Open3.capture2e(Boresight.program('boresight-passwd'), file, *words, stdin_data: input)
  end

  # Makes all of PASSWORDS.
  def self.make(file)
    PASSWORDS.each do |name, (role, password)|
      answer, status = passwd(file, 'set', name, role, input: "#{password}\n")
      raise answer unless status.success?
    end
    file
  end

  # The same, until all tests have run.
  def self.make_for_a_while
    folder = Dir.mktmpdir('accounts')
    Minitest.after_run { FileUtils.rm_rf(folder) }
    make(File.join(folder, 'accounts'))
  end
end

# A page of the console, or a program: it logs in, and acts.
class SessionClient
  PATH = '/api/v1/session'
  AUTHORITY = '/api/v1/authority'
  TOKEN = 'X-Boresight-Token'
  PAGE = 'X-Boresight-Page'

  attr_reader :port, :last
  attr_accessor :cookie, :token, :page, :id, :mark

  def initialize(port)
    @port = port
    @page = rand(1..0xFFFFFFFF)
    @id = 0
  end

  # Another page of the same session.
  def another_page
    dup.tap { |one| one.page = rand(1..0xFFFFFFFF) }
  end

  # Does something new; or again with the `id` of what was asked for before.
  def act(path, fields = {}, id: nil)
    @id += 1 unless id
    @last = request('post', "/api/v1/#{path}", JSON.generate({ id: id || @id }.merge(fields)), PAGE => page.to_s)
  end

  def take
    act('authority')
  end

  def keep
    request('put', AUTHORITY, nil, PAGE => page.to_s)
  end

  def give_up
    request('delete', AUTHORITY, nil, PAGE => page.to_s)
  end

  # The answer to a request with the cookie and, if it writes, the token.
  def request(method, path, body = nil, headers = {})
    message = Net::HTTP.const_get(method.capitalize).new(path, all_headers(method, body).merge(headers).compact)
    message.body = body
    Net::HTTP.start('127.0.0.1', port, open_timeout: Boresight::TIMEOUT_SECONDS,
                                       read_timeout: Boresight::TIMEOUT_SECONDS) { |http| http.request(message) }
  end

  def post_login(body, headers = {})
    @last = request('post', PATH, JSON.generate(body), headers)
    return @last unless @last.code == '200'

    @cookie, @mark = @last.get_fields('Set-Cookie').map { |set| set.split(';').first }
    @token = JSON.parse(@last.body).fetch('token')
    @last
  end

  def log_in(name, password = Accounts::PASSWORDS.fetch(name).last)
    post_login({ name: name, password: password })
  end

  def show
    JSON.parse(request('get', PATH).body)
  end

  def renew(headers = {})
    request('put', PATH, nil, headers)
  end

  def log_out(headers = {})
    request('delete', PATH, nil, headers)
  end

  private

  def all_headers(method, body)
    { 'Cookie' => cookie, TOKEN => (token unless method == 'get'), 'Content-Type' => ('application/json' if body) }
  end
end
