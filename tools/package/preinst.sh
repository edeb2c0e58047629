# SPDX-License-Identifier: Apache-2.0
require_rest
stop_running
