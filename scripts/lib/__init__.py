"""What the scripts share; no file in here is run by itself."""
