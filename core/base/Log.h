// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLoggingCategory>

namespace core {

/// The logging category. At the default level, messages never contain a patient's name, identifiers
/// or file paths.
Q_DECLARE_LOGGING_CATEGORY(log)

} // namespace core
