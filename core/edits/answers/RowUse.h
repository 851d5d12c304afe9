// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// What an edit does with the rows of the history that it names.
enum class RowUse {
    None, ///< it names none
    TakesBack, ///< as long as it is in effect, they are not
    Revises, ///< it gives them another form; they stay in effect
};

} // namespace core
