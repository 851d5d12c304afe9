// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/ErrorText.h"

#include <QTest>

/// Verifies that a Result holds a value; else its error is the message.
#define VERIFY_DONE(result)                                                                        \
    QVERIFY2((result).has_value(), (result) ? "" : qPrintable(ui::errorText((result).error())))

/// Verifies that a Result holds this error.
#define VERIFY_ERROR(result, expected)                                                             \
    QVERIFY(!(result).has_value());                                                                \
    QVERIFY2((result).error().code == (expected), qPrintable(ui::errorText((result).error())))
