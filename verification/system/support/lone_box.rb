# SPDX-License-Identifier: Apache-2.0
# frozen_string_literal: true

require_relative 'boresight'

# A simulated box that runs by itself, with the name @box: it is switched off and on while the programs are not there.
module LoneBox
  def switch_box_on
    said, output = IO.pipe
    @box_pid = Process.spawn(Boresight.program('boresight-box'), '--name', @box, out: output, err: File::NULL)
    output.close
    wait_until('the box is ready') { said.wait_readable(1) && said.gets.to_s.include?('ready') }
  ensure
    said&.close
  end

  def switch_box_off
    Process.kill('TERM', @box_pid)
    Process.wait(@box_pid)
  end
end
