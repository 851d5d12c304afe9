// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace core {

/// Initialises DCMTK once for the process: its own data dictionary, codecs, no messages (its
/// warnings quote patients' names). To be called before any use of DCMTK; any thread. Codecs stay
/// registered until exit.
void readyDcmtk();

} // namespace core
