// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"

#include <tl/expected.hpp>

#include <utility>

namespace core {

/// A value, or the reason why there is none. `tl::expected` because clang 14 cannot compile
/// `std::expected`.
template <class T> using Result = tl::expected<T, Error>;

/// `return failure(ErrorCode::FileNotFound, path);`
template <class... Arguments>
[[nodiscard]] tl::unexpected<Error> failure(ErrorCode code, const Arguments&... arguments)
{
    return tl::unexpected<Error>(Error{code, {Clause(arguments)...}});
}

} // namespace core
