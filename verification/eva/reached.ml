(* SPDX-License-Identifier: Apache-2.0 *)
(* Once Eva has ended, a line for each function that it has reached: `reached: FILE: NAME`, the name as the source has it. *)
let say kf =
  let place = fst (Kernel_function.get_location kf) in
  let name = (Kernel_function.get_vi kf).Cil_types.vorig_name in
  if Kernel_function.is_definition kf && !Db.Value.is_called kf then
    Kernel.feedback "reached: %a: %s" Filepath.Normalized.pretty place.Filepath.pos_path name

let () = Db.Main.extend (fun () -> if Db.Value.is_computed () then Globals.Functions.iter say)
