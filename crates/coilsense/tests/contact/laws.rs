use super::reference as _;
