#include "tests/bench/estimator_table/printer_tracker.hpp"

template class articam::tracker::Tracker<articam::models::PrinterDrawer, double>;
