// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

/// How much memory the last steps' differences may take, uncompressed, so that undo needs no disk:
/// a setting of the user's.
constexpr int leastHistoryMebibytes = 16;
constexpr int mostHistoryMebibytes = 4096;
constexpr int usualHistoryMebibytes = 256;

[[nodiscard]] int historyMebibytes();
/// Brought into the bounds. Workspace::applyHistoryMemory() makes the open session heed it.
void setHistoryMebibytes(int mebibytes);

} // namespace ui
