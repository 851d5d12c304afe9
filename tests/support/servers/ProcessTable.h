// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace test {

/// A running process of this machine.
struct RunningProcess {
    qint64 pid = 0;
    qint64 parent = 0;
    QStringList words; ///< its command line
};

/// Returns all processes whose command line can be read. Those that have ended and wait for their
/// parent are not among them.
[[nodiscard]] std::vector<RunningProcess> runningProcesses();
/// Stops a process by SIGSTOP. @return whether it stands still now and had not ended before
[[nodiscard]] bool holdProcess(qint64 pid);

} // namespace test
