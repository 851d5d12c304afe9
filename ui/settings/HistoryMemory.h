// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

/// How much memory the differences of the last steps may take uncompressed, so that undo needs no
/// disk access: a setting of the user.
constexpr int leastHistoryMebibytes = 16;
constexpr int mostHistoryMebibytes = 4096;
constexpr int usualHistoryMebibytes = 256;

[[nodiscard]] int historyMebibytes();
/// Sets it, clamped to the bounds. Workspace::applyHistoryMemory() applies it to the open session.
void setHistoryMebibytes(int mebibytes);

} // namespace ui
