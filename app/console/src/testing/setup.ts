// SPDX-License-Identifier: Apache-2.0
// A bound against hanging, and no judgement: a busy machine takes its time to load a part that comes when it is needed.
import { configure } from "@testing-library/react";

configure({ asyncUtilTimeout: 20_000 });
