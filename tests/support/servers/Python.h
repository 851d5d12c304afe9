// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace test {

/// The output of an independent reader (pydicom, nibabel).
struct ScriptOutput {
    int exitCode = -1;
    QByteArray output; ///< standard output
    QString errors; ///< standard error, for the test's message
};

/// Runs tests/support/python/@p script with Debian's Python (the one that has the packages).
ScriptOutput runScript(const QString& script, const QStringList& arguments);

/// Runs a program found on the path; its two outputs are joined in `output`.
ScriptOutput runProgram(const QString& program, const QStringList& arguments);

} // namespace test
