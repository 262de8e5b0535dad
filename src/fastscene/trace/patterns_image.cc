#include "fastscene/trace/kernel/picture.h"
