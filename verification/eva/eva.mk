# SPDX-License-Identifier: Apache-2.0
# The controller by abstract interpretation; included by the Makefile.

.PHONY: eva eva-list
EVA_ROBOTS := $(or $(ROBOT),$(DEFAULT_ROBOT))

eva: bootstrap-test generated ## Run-time errors of the controller for any inputs, by Frama-C's Eva; ROBOT="neuro prostate" chooses the robots
	@ruby tools/eva/run.rb $(EVA_ROBOTS)

eva-list: bootstrap-test generated ## Its lists anew: verification/eva/alarms.yml, verification/proof/proved.yml
	@ruby tools/eva/run.rb --write $(EVA_ROBOTS)
