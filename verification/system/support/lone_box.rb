# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'boresight'

# A simulated box that runs by itself with each test, with the name @box, and @directory for what the programs keep: it is
# switched off and on while the programs are not there. Its robot is ROBOT, which homes in a quarter of the default one's time, and
# it can be fast: homing that no test looks at passes in fast time, all else at the pace of the world.
module LoneBox
  ROBOT = 'bench2'

  def setup
    super
    @directory = Dir.mktmpdir('boresight')
    @box = "#{Boresight.next_instance}-box"
    switch_box_on
  end

  def teardown
    super
    switch_box_off
    FileUtils.rm_rf(@directory)
  end

  def switch_box_on
    said, output = IO.pipe
    @box_pid = Process.spawn(Boresight.program('boresight-box'), '--box', @box, '--robot', ROBOT, *Boresight::FAST, out: output, err: File::NULL)
    output.close
    wait_until('the box is ready') { said.wait_readable(1) && said.gets.to_s.include?('ready') }
    simctl('pace', '1')
  ensure
    said&.close
  end

  # Gives the box an order; returns its answer.
  def simctl(*words)
    answer, status = Open3.capture2e(Boresight.program('boresight-simctl'), '--box', @box, *words)
    assert status.success?, answer
    answer
  end

  def switch_box_off
    Process.kill('TERM', @box_pid)
    Process.wait(@box_pid)
  end
end
