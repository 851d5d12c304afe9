// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// `burin --decode-worker`: a process that Burin starts itself to decode images, because it trusts
/// no byte of them (core/fence/README.md). It is not a command for users.
[[nodiscard]] bool isDecoder(int argc, char** argv);
int runDecoder();

/// Makes this program decode images in such processes from now on.
void nameDecoders();

} // namespace app
