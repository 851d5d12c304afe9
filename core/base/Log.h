// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLoggingCategory>

namespace core {

/// Messages for the log never hold a patient's name, identifiers or file paths at the default
/// level.
Q_DECLARE_LOGGING_CATEGORY(log)

} // namespace core
