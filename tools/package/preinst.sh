# SPDX-License-Identifier: Apache-2.0
stop_at_rest
