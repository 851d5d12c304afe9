// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Readies DCMTK once for the process: its own data dictionary, codecs, no messages (its warnings
/// quote patients' names). Call before any use of DCMTK; any thread. Codecs stay until exit.
void readyDcmtk();

} // namespace core
