// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// `burin --decode-worker`: started by Burin itself, for images of which it trusts no byte
/// (core/fence/README.md). No command for people.
[[nodiscard]] bool isDecoder(int argc, char** argv);
int runDecoder();

/// From now on this program decodes in processes of itself.
void nameDecoders();

} // namespace app
