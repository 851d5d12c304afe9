// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/RowOrigin.h"

#include <QByteArray>
#include <QString>

#include <functional>

#include <sys/types.h>

namespace test {

/// A session on the small study with the rows of manyEdits(), then two more from row 4 on,
/// closed one row before the last, with segment 2 hidden.
/// @return the state hash there
QByteArray makeSession(const QString& path, std::function<core::RowOrigin()> origin = {});

/// The small study as a CT series in a folder; @p shift makes another one of it, by grey values.
void writeSmallSeries(
    const QString& folder, const char* seriesUid, int shift = 0, const char* description = "");

/// One statement on a closed session file. @return whether it changed something
bool runSql(const QString& path, const QString& sql);

/// The one value that a query on a closed session file answers.
[[nodiscard]] QString text(const QString& path, const QString& sql);

/// SHA-256 of a file's bytes, hex.
[[nodiscard]] QByteArray fingerprint(const QString& path);

/// While it lives, this process is nobody, if it was root: permissions count.
class Unprivileged {
public:
    Unprivileged();
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;
    ~Unprivileged();

private:
    bool m_wasRoot = false;
};

/// While it lives, another process holds a session file as a window does that has it open.
class OtherWindow {
public:
    explicit OtherWindow(const QString& path);
    OtherWindow(const OtherWindow&) = delete;
    OtherWindow& operator=(const OtherWindow&) = delete;
    ~OtherWindow();

private:
    pid_t m_process = -1;
};

} // namespace test
