// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/base/ErrorText.h"

#include <QTest>

/// A Result that must be a value; else its sentence is the message.
#define VERIFY_DONE(result)                                                                        \
    QVERIFY2((result).has_value(), (result) ? "" : qPrintable(ui::errorText((result).error())))

/// A Result that must be this error.
#define VERIFY_ERROR(result, expected)                                                             \
    QVERIFY(!(result).has_value());                                                                \
    QVERIFY2((result).error().code == (expected), qPrintable(ui::errorText((result).error())))
