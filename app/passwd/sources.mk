# SPDX-License-Identifier: Apache-2.0
# Sources that this program is linked from, beside libcore.a; included by the Makefile.

SOURCES_boresight-passwd := $(wildcard app/passwd/*.c) app/http/login/account.c app/http/login/password.c
LIBS_boresight-passwd := -lcrypt
