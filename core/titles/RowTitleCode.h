// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// What a row of the history says it did, or a part of that: RowTitles.def lists them. The values
/// have no gaps from 0 on; files hold them by name, never by number.
enum class RowTitleCode : std::uint16_t {
#define ROW_TITLE(code, ...) code,
#include "core/titles/RowTitles.def"
#undef ROW_TITLE
};

} // namespace core
