// SPDX-License-Identifier: Apache-2.0
#include "core/base/Log.h"

namespace core {

Q_LOGGING_CATEGORY(log, "burin.core", QtInfoMsg)

} // namespace core
