// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <chrono>
#include <vector>

namespace test {

/// Every hostile file that there is (HostileDicom.h).
struct HostileFile {
    QString name; ///< what it is
    QByteArray bytes;
};
[[nodiscard]] std::vector<HostileFile> hostileFiles();

/// The series that a hostile file lies beside: twelve slices in JPEG lossless.
constexpr int honestSlices = 12;
[[nodiscard]] QString honestSeriesUid();
/// @return its files, slice by slice
QStringList writeHonestSeries(const QString& folder);

/// No time that decides: only a hang takes that long on a machine that has nothing else to do, and
/// the issue allows ten seconds of work.
constexpr std::chrono::seconds hangsAfter{240};

/// `burin`, run to its end or until it hangs.
struct WatchedRun {
    bool hung = false;
    int status = -1; ///< −1: it crashed
    double cpuSeconds = 0.0; ///< of all threads; what ten seconds are counted by
    long peakKb = 0; ///< the most memory that it, or one process that it started, had
    QByteArray output; ///< stdout
    QString complaint; ///< stderr
};
[[nodiscard]] WatchedRun watchedBurin(const QStringList& arguments);

} // namespace test
