// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// A piece is one no more. What cut it stays cut.
struct RemovePiece {
    int piece = 0; ///< id
};

} // namespace core
