# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: one file installs everything; releases change places in one step, at rest alone, and one can go back;
# configuration and recordings are the engineer's.

require_relative 'bare_tree'

BareTree.enter

require_relative '../../tools/package'
require_relative '../system/support/system_test'
require_relative '../system/support/igtl_client'

class TestReleases < SystemTest
  ROOT = File.expand_path('../..', __dir__)
  KIND = Package::KINDS.first
  OLD = '1.0'
  NEW = '1.1'
  NEWEST = '1.2'
  CONFIGURATION = '/etc/boresight/boresight.conf'

  def self.packages
    @packages ||= Dir.mktmpdir.then do |folder|
      Minitest.after_run { FileUtils.rm_rf(folder) }
      Dir.chdir(ROOT) do
        [OLD, NEW, NEWEST].to_h { |version| [version, Package.new(KIND, 'sim', Package::State.new(0, version)).write(folder)] }
      end
    end
  end

  def setup
    libraries = Dir.chdir(ROOT) { Soup.new(File.read(Soup::FILE)).items('sim').filter_map(&:library) }
    @tree = BareTree.new(libraries)
  end

  def teardown
    super
    @tree.remove
  end

  def package(*words)
    @tree.run('dpkg', *words)
  end

  def install(version)
    package('--install', self.class.packages.fetch(version))
  end

  def assert_done(result)
    assert_equal 0, result.last, result.first
    result.first
  end

  def leads(link)
    File.basename(File.readlink(@tree.path("/opt/boresight/#{link}")))
  end

  def start_installed
    boresight(prefix: @tree.prefix, programs: '/opt/boresight/current/bin',
              arguments: ['--config', CONFIGURATION, '--robot', 'bench2'])
  end

  def test_SWR_PACK_004_one_file_installs_everything
    assert_done(install(OLD))
    text = assert_done(@tree.run('boresight', '--version'))
    assert_equal text, Open3.capture2("#{ROOT}/build/bin/boresight", '--version').first
    assert_done(@tree.run('boresight-rollback', '--help'))
    assert_done(@tree.run('boresight-replay', '--help'))
    assert_match(/^# Provides: +boresight$/, File.read(@tree.path('/etc/init.d/boresight')))
    %w[LimitRTPRIO=90 LimitMEMLOCK=infinity KillSignal=SIGINT Restart=no].each do |line|
      assert_includes File.readlines(@tree.path('/lib/systemd/system/boresight.service'), chomp: true), line
    end
    assert_equal [OLD], Dir.children(@tree.path('/opt/boresight/releases'))
    share = @tree.path('/opt/boresight/current/share')
    File.read("#{share}/commissioning.md").scan(/\]\(([\w-]+\.md)/).flatten.each { |page| assert_path_exists "#{share}/#{page}" }
  end

  def test_SWR_PACK_012_the_script_of_the_service_starts_and_stops_it
    assert_done(install(OLD))
    configure
    assert_equal ["Boresight does not run.\n", 3], service('status')
    assert_equal ['', 0], service('start')
    wait_until('it runs') { service('status') == ["Boresight runs.\n", 0] }
    wait_until('it records') { Dir.children(@tree.path('/var/lib/boresight')).grep(/\.bsr\z/).any? }
    assert_equal ["Boresight runs already.\n", 0], service('start')
    assert_equal ['', 0], service('stop')
    assert_equal 3, service('status').last
  end

  # Configuration that a service runs with.
  def configure(more = '')
    @ports ||= %w[http-port brp-port igtl-port].zip(Boresight.free_ports(3)).map { |pair| "#{pair.join(' ')}\n" }.join
    File.write(@tree.path(CONFIGURATION), "#{@ports}recordings /var/lib/boresight\nrobot bench2\n#{more}")
  end

  # Whether it is at rest would be asked of an instance that does not run.
  def test_SWR_PACK_008_nothing_is_replaced_whose_options_have_changed_since_its_start
    assert_done(install(OLD))
    configure
    service('start')
    wait_until('it records') { Dir.children(@tree.path('/var/lib/boresight')).grep(/\.bsr\z/).any? }
    configure("instance another\n")
    text, code = install(NEW)
    refute_equal 0, code, text
    assert_match(/its options have changed since its start; .*No Boresight runs with the name "another"/, text)
    assert_equal [OLD, ["Boresight runs.\n", 0]], [leads('current'), service('status')]
  ensure
    service('stop')
  end

  # It was started from what was unpacked, on a disk of its own; it does not answer whether it is at rest.
  def test_SWR_PACK_008_what_runs_from_elsewhere_below_its_folder_is_not_replaced
    FileUtils.mkdir_p(@tree.path('/srv/opt'))
    File.symlink('srv/opt', @tree.path('/opt'))
    assert_done(install(OLD))
    program = '/opt/boresight/package/bin/boresight'
    FileUtils.cp('/bin/sleep', @tree.path("/srv#{program}"))
    pid = Process.spawn(*@tree.prefix, program, '600')
    wait_until('it runs') { File.readlink("/proc/#{pid}/exe").end_with?(program) }
    text, code = install(NEW)
    refute_equal 0, code, text
    assert_match(/nothing is replaced, process #{pid} runs/, text)
    assert_equal OLD, leads('current')
  ensure
    Process.kill(:KILL, pid)
    Process.wait(pid)
  end

  def test_SWR_PACK_013_a_release_that_does_not_fit_the_configuration_is_refused_by_name
    [OLD, NEW].each { |version| assert_done(install(version)) }
    { 'robot dental' => /There is no robot "dental"/, 'wiring x' => /wiring/ }.each do |line, reason|
      File.write(@tree.path(CONFIGURATION), "#{line}\n")
      [%w[boresight-rollback], ['dpkg', '--install', self.class.packages.fetch(NEWEST)]].each do |command|
        text, code = @tree.run(*command)
        refute_equal 0, code, text
        assert_match(/nothing is replaced, the release does not fit #{CONFIGURATION}.*#{reason}/m, text)
      end
      assert_equal [NEW, OLD], [leads('current'), leads('previous')]
    end
    File.write(@tree.path(CONFIGURATION), "robot bench2\n")
    assert_done(package('--configure', 'boresight'))
    assert_equal [NEWEST, NEW], [leads('current'), leads('previous')]
  end

  # Between the two halves of an installation an engineer may start it.
  def test_SWR_PACK_008_what_was_started_in_the_middle_of_an_installation_is_not_replaced
    assert_done(install(OLD))
    assert_done(package('--unpack', self.class.packages.fetch(NEW)))
    start_installed
    boresight.await_released_pedal
    boresight.command('START_UP')
    wait_until('it waits for the pedal') { boresight.status['order'] == 'waiting' }
    text, code = package('--configure', 'boresight')
    refute_equal 0, code, text
    assert_match(/A motion is armed/, text)
    assert_equal [OLD, 5], [leads('current'), boresight.pids.size]
  end

  def service(act)
    @tree.run('/etc/init.d/boresight', act)
  end

  def test_SWR_PACK_003_it_reports_the_versions_that_must_fit_together
    assert_done(install(OLD))
    version = @tree.run('boresight', '--version').first[/ (.*)$/, 1]
    start_installed
    wait_until('it says so') { boresight.output.include?('Version:') }
    assert_match(/^Version:     #{Regexp.escape(version)}, robot bench2 \(file \h{8}\), card protocol 1$/, boresight.output)
  end

  def test_SWR_PACK_007_SWR_PACK_009_releases_change_places_and_two_are_kept
    assert_done(install(OLD))
    assert_match(/boresight: there is no release before this one/, @tree.run('boresight-rollback').first)
    assert_done(install(NEW))
    assert_equal [NEW, OLD], [leads('current'), leads('previous')]
    assert_done(@tree.run('boresight-rollback'))
    assert_equal [OLD, NEW], [leads('current'), leads('previous')]
    assert_done(@tree.run('boresight', '--version'))
    assert_done(@tree.run('boresight-rollback'))
    assert_equal [NEW, OLD], [leads('current'), leads('previous')]
    assert_done(install(NEWEST))
    assert_equal [NEWEST, NEW], [leads('current'), leads('previous')]
    assert_equal [NEW, NEWEST], Dir.children(@tree.path('/opt/boresight/releases')).sort
  end

  # Looked at a thousand times while they change places.
  def test_SWR_PACK_007_there_is_always_a_current_release
    [OLD, NEW].each { |version| assert_done(install(version)) }
    link = @tree.path('/opt/boresight/current')
    swaps = Thread.new { 5.times.map { @tree.run('boresight-rollback').last } }
    looks = 0
    while swaps.alive?
      assert_includes [OLD, NEW], File.basename(File.readlink(link))
      looks += 1
    end
    assert_equal [0], swaps.value.uniq
    assert_operator looks, :>, 100
  end

  def test_SWR_PACK_002_SWR_PACK_008_nothing_is_replaced_under_a_drive_or_a_procedure
    [OLD, NEW].each { |version| assert_done(install(version)) }
    start_installed
    boresight.await_released_pedal
    boresight.command('START_UP')
    wait_until('it waits for the pedal') { boresight.status['order'] == 'waiting' }
    assert_refused(/A motion is armed/)
    boresight.simctl('pedal', 'press')
    wait_until('an axis is driven') { boresight.moving? }
    # Nothing goes on meanwhile.
    boresight.while_stopped('control', 'box') { assert_refused(/The drive of \w+ is on/) }
    boresight.home
    boresight.command('PLANNING')
    wait_until('it plans') { boresight.status.dig('workphase', 'name') == 'PLANNING' }
    assert_refused(/The workphase is PLANNING, a client has left START_UP/)
  end

  # Each way to replace it.
  def assert_refused(reason)
    before = Dir.children(@tree.path('/opt/boresight/releases')).sort
    [%w[boresight-rollback], ['dpkg', '--install', self.class.packages.fetch(OLD)], %w[dpkg --remove boresight]].each do |command|
      text, code = @tree.run(*command)
      refute_equal 0, code, text
      assert_match(reason, text)
    end
    assert_equal [before, NEW, OLD], [Dir.children(@tree.path('/opt/boresight/releases')).sort, leads('current'), leads('previous')]
    assert_equal 5, boresight.pids.size
  end

  def test_SWR_PACK_008_at_rest_it_is_stopped_and_replaced
    assert_done(install(OLD))
    start_installed
    assert_done(install(NEW))
    assert_equal [0, NEW], [boresight.wait_for_end, leads('current')]
  end

  def test_SWR_PACK_010_the_configuration_stays_until_it_is_purged_and_recordings_for_ever
    assert_done(install(OLD))
    File.write(@tree.path(CONFIGURATION), "recordings /var/lib/boresight\nrobot bench2\n")
    File.write(@tree.path('/var/lib/boresight/blackbox-1.bsr'), 'evidence')
    assert_done(install(NEW))
    assert_done(package('--remove', 'boresight'))
    refute_path_exists @tree.path('/opt/boresight')
    assert_match(/^robot bench2$/, File.read(@tree.path(CONFIGURATION)))
    assert_match(%r{Recordings stay in /var/lib/boresight}, assert_done(package('--purge', 'boresight')))
    refute_path_exists @tree.path('/etc/boresight')
    assert_equal 'evidence', File.read(@tree.path('/var/lib/boresight/blackbox-1.bsr'))
  end
end
