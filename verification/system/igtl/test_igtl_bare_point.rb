# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

# Rule under test: a target that is a bare point, as navigation programs send one to the ProstateRobot, is weighed along the
# robot's own direction; a robot that has none waits for the entry point.

require_relative '../support/igtl_client'
require_relative '../support/system_test'

class TestIgtlBarePoint < Minitest::Test
  IDENTITY = '1 0 0 0 0 1 0 0 0 0 1 0'
  FORWARD_MM = 20

  # Homed and registered.
  def with_robot(name)
    system = Boresight.start(arguments: ['--robot', name, *Boresight::FAST])
    system.home_fast
    system.leave
    system.wait_until('nobody commands') { system.status['authority']['state'] == 'nobody' }
    IgtlClient.open(system.brp_port) { |client| register(client) }
    yield system
  ensure
    system&.stop
  end

  def register(client)
    client.phase('CALIBRATION')
    client.run("registration #{IDENTITY}")
    client.run('expect STATUS CALIBRATION 1')
  end

  # As a client of bare transforms: rotation and position of the needle, in mm.
  def pose(client, name)
    client.await('TRANSFORM', name).fetch('matrix').each_slice(4).map { |row| [row.first(3), row.last] }.transpose
  end

  def propose(client, point)
    x, y, z = point
    client.run("transform TARGET_POINT 1 0 0 #{x} 0 1 0 #{y} 0 0 1 #{z}")
    assert_equal(point, client.await('POINT', 'target_point')['position'])
  end

  def test_SWR_IGTL_120_a_bare_target_of_the_prostate_robot_is_reached_along_the_bore
    with_robot('prostate') do |system|
      IgtlClient.open(system.igtl_port) do |client|
        point = pose(client, 'measured_cp').last.map(&:round)
        point[2] += FORWARD_MM
        propose(client, point)
        rotation, position = pose(client, 'desired_cp')
        rotation.transpose.last.zip([0, 0, 1]).each { |is, wanted| assert_in_delta wanted, is, 0.001 }
        position.zip(point).each { |is, wanted| assert_in_delta wanted, is, 0.01 }
        assert_equal system.motors['axes'].size, client.await('STRING', 'desired_jp')['text'].split(',').size
        refused_far_away(client, point)
      end
      assert_nil system.targeting['target'], 'a proposal is no target'
    end
  end

  # No pose is said of a point that cannot be reached.
  def refused_far_away(client, point)
    propose(client, [point[0], point[1] + 500, point[2]])
    client.run('expect STATUS desired_cp 4')
  end

  def test_SWR_IGTL_120_a_bare_target_of_the_neuro_robot_waits_for_its_entry
    with_robot('neuro') do |system|
      IgtlClient.open(system.igtl_port) do |client|
        propose(client, [0, 190, 60])
        client.run('ask GET_TRANS desired_cp')
        client.run('expect STATUS desired_cp 4')
      end
    end
  end
end
