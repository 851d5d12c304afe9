// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/shaders/ShaderLibrary.h"

#include <QByteArray>
#include <QTemporaryDir>

namespace test {

/// The built-in shaders in a folder, with lines inserted before the ray caster's source, so that
/// its pictures can be compared with the product's.
[[nodiscard]] gpu::ShaderLibrary changedRaycaster(
    const QTemporaryDir& folder, const QByteArray& lines);

} // namespace test
