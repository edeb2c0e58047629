# SPDX-License-Identifier: Apache-2.0
"""cppcheck's own MISRA addon, as cppcheck starts it once for every file.

Imported, so that Python keeps it compiled from file to file, and without collecting garbage: it lives for one file.
"""
import gc
import sys

gc.disable()

import cppcheckdata  # noqa: E402
import misra  # noqa: E402

misra.main()
sys.exit(cppcheckdata.EXIT_CODE)
