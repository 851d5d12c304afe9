// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/RowOrigin.h"

#include <QByteArray>
#include <QString>

#include <functional>

#include <sys/types.h>

namespace test {

/// Makes a closed session on the small study with the rows of manyEdits(), then two more after row
/// 4; its position is one row before the last, and segment 2 is hidden.
/// @return the state hash at that position
QByteArray makeSession(const QString& path, std::function<core::RowOrigin()> origin = {});

/// Writes the small study as a CT series into a folder; a @p shift of the grey values makes it a
/// different study.
void writeSmallSeries(
    const QString& folder, const char* seriesUid, int shift = 0, const char* description = "");

/// Runs one SQL statement on a closed session file.
/// @return whether it changed anything
bool runSql(const QString& path, const QString& sql);

/// The single value that a query on a closed session file returns.
[[nodiscard]] QString text(const QString& path, const QString& sql);

/// SHA-256 of a file's bytes, hex.
[[nodiscard]] QByteArray fingerprint(const QString& path);

/// While it lives, this process runs as nobody if it was root, so that file permissions apply.
class Unprivileged {
public:
    Unprivileged();
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;
    ~Unprivileged();

private:
    bool m_wasRoot = false;
};

/// While it lives, another process holds a session file open, as another window would.
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
