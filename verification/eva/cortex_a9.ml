(* SPDX-License-Identifier: Apache-2.0 *)
(* The machine model of the Cortex-A9 (ARM EABI, 32 bit, little-endian), which Frama-C does not bring: as its 32-bit x86,
   but 64-bit numbers lie on addresses that are a multiple of 8, `char` is unsigned, `long double` is `double`. *)
let () =
  File.new_machdep "cortex_a9"
    { Machdeps.gcc_x86_32 with
      version = "arm-linux-gnueabihf-gcc";
      alignof_longlong = 8;
      alignof_double = 8;
      sizeof_longdouble = 8;
      alignof_longdouble = 8;
      alignof_aligned = 8;
      wchar_t = "unsigned int";
      char_is_unsigned = true;
      cpp_arch_flags = [] }
