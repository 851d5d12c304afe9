// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// An empty sculpt layer, last in the list.
struct AddLayer {
    QString name{};
};

} // namespace core
